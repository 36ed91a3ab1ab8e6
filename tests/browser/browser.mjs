// SPDX-License-Identifier: MIT
//
// A browser driven over the DevTools protocol, by a pipe: Chromium reads commands from file descriptor 3 and answers on
// 4, each message ended by a zero byte. No package is needed for it. What the page logs, throws or asks of the network
// is kept.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const flags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--hide-scrollbars',
               '--disable-background-networking', '--disable-component-update', '--disable-sync',
               '--remote-debugging-pipe'];

export class Browser {
    static async start(program) {
        const browser = new Browser();
        browser.profile = mkdtempSync(join(tmpdir(), 'edgewise_browser_'));
        browser.process = spawn(program, [...flags, '--user-data-dir=' + browser.profile, 'about:blank'],
                                { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
        browser.waiting = new Map();
        browser.listeners = [];
        browser.number = 0;
        let rest = '';
        browser.process.stdio[4].on('data', data => {
            const messages = (rest + data).split('\0');
            rest = messages.pop();
            messages.forEach(message => browser.take(JSON.parse(message)));
        });
        return browser;
    }

    take(message) {
        if (message.id === undefined) return this.listeners.forEach(listener => listener(message));
        const { done, failed } = this.waiting.get(message.id);
        this.waiting.delete(message.id);
        if (message.error) failed(new Error(message.error.message));
        else done(message.result);
    }

    send(method, params = {}, sessionId = undefined) {
        const id = ++this.number;
        this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
        return new Promise((done, failed) => this.waiting.set(id, { done, failed }));
    }

    async open(settings = {}) {
        const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
        const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
        return Page.open(this, sessionId, settings);
    }

    async stop() {
        const ended = new Promise(done => this.process.once('exit', done));
        this.send('Browser.close').catch(() => {});
        await ended;
        rmSync(this.profile, { recursive: true, force: true });
    }
}

export class Page {
    /// width, height; dark; scripts: whether they run; media: "print" or "screen".
    static async open(browser, sessionId, { width = 1300, height = 900, dark = false, scripts = true, media = 'screen' }) {
        const page = new Page();
        Object.assign(page, { browser, sessionId, requests: [], complaints: [] });
        browser.listeners.push(message => message.sessionId === sessionId && page.notice(message));
        for (const domain of ['Page', 'Runtime', 'Network', 'Log']) await page.send(domain + '.enable');
        await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
        await page.send('Emulation.setEmulatedMedia', {
            media, features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
        if (!scripts) await page.send('Emulation.setScriptExecutionDisabled', { value: true });
        return page;
    }

    send(method, params) { return this.browser.send(method, params, this.sessionId); }

    notice({ method, params }) {
        if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
        if (method === 'Runtime.exceptionThrown') this.complaints.push(params.exceptionDetails.exception?.description);
        if (method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(params.type))
            this.complaints.push(params.args.map(arg => arg.value ?? arg.description).join(' '));
        if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(params.entry.text);
        if (method === 'Page.loadEventFired') this.loaded?.();
    }

    async go(url) {
        const loaded = new Promise(done => { this.loaded = done; });
        await this.send('Page.navigate', { url });
        await loaded;
    }

    /// The value of an expression, of a promise what it gives.
    async value(expression) {
        const { result, exceptionDetails } = await this.send(
            'Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
    }

    /// Waits until an expression is true.
    until(expression, seconds = 20) {
        return this.value(`new Promise((done, failed) => {
            const end = Date.now() + ${seconds * 1000};
            const look = () => (${expression}) ? done(true)
                : Date.now() > end ? failed(new Error(${JSON.stringify('waited in vain for ' + expression)}))
                : setTimeout(look, 30);
            look(); })`);
    }

    async picture(clip = undefined) {
        const { data } = await this.send('Page.captureScreenshot',
                                         { format: 'png', captureBeyondViewport: true,
                                           ...(clip && { clip: { ...clip, scale: 1 } }) });
        return Buffer.from(data, 'base64');
    }

    async pdf() {
        const { data } = await this.send('Page.printToPDF', { printBackground: true });
        return Buffer.from(data, 'base64');
    }
}
