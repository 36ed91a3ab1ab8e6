# SPDX-License-Identifier: MIT
#
# A ReFrame test (reframe-hpc.readthedocs.io, 4.x) of an installed Edgewise: a quick sweep on a node of its own.
# The test is sane if every cell was verified. ReFrame keeps the figures of merit.
import os

import reframe as rfm
import reframe.utility.sanity as sn


@rfm.simple_test
class EdgewiseSweep(rfm.RunOnlyRegressionTest):
    descr = 'Layouts of convex collision detection: every answer checked, times over the baseline'
    valid_systems = ['*']
    valid_prog_environs = ['*']
    executable = 'edgewise'
    executable_opts = ['sweep', '--plan', 'quick', '--fom']
    exclusive_access = True
    time_limit = '30m'

    @sanity_function
    def every_cell_is_verified(self):
        return sn.all([sn.assert_found(r'^FOM cells_failed = 0 cells$', self.stdout),
                       sn.assert_found(r'^FOM answers_wrong = 0 queries$', self.stdout)])

    @run_before('performance')
    def take_figures_of_merit(self):
        output = os.path.join(self.stagedir, sn.evaluate(self.stdout))  # hooks run elsewhere
        figures = sn.extractall(r'^FOM (time_ratio\.\S+) = (\S+) 1$', output, (1, 2), (str, float))
        for name, ratio in sn.evaluate(figures):
            self.perf_variables[name] = sn.make_performance_function(sn.defer(ratio), '1')
