// SPDX-License-Identifier: BSD-3-Clause
// Requests to the server, and its events. DESIGN.md documents them.

class Server {
  constructor(root) {
    this.root = root;
  }

  /** Posts a request; throws an error with the server's sentence if it is refused. */
  async ask(name, body = {}) {
    const reply = await fetch(`${this.root}api/${name}`, {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(body)});
    const answer = await reply.json();
    if (!reply.ok) throw Object.assign(new Error(answer.error || `status ${reply.status}`), {status: reply.status});
    return answer;
  }

  /** Calls the function of each event with its data; `onEnd` when the program has ended. */
  listen(after, functions, onEnd) {
    this.source = new EventSource(`${this.root}events?after=${after}`);
    for (const [name, act] of Object.entries(functions)) this.source.addEventListener(name, (event) => act(JSON.parse(event.data)));
    this.source.addEventListener('error', () => { if (this.source.readyState === EventSource.CLOSED) onEnd(); else this.ask('state').catch(onEnd); });
  }
}
