document.querySelectorAll('script[type="application/json"][data-chart]').forEach(source => {
    const element = document.getElementById('chart-' + source.dataset.chart);
    const fallback = element.innerHTML;
    const options = { mode: 'vega-lite', renderer: 'svg', ast: true, tooltip: { theme: 'light' },
                      actions: { export: true, source: false, compiled: false, editor: false } };
    vegaEmbed(element, JSON.parse(source.textContent), options).catch(failure => {
        element.innerHTML = fallback;
        element.insertAdjacentText('beforebegin', 'This chart could not be drawn: ' + failure.message);
        console.error(failure);
    });
});
