// Sources of events: a run of the server, or a file that the page itself reads.

const token = new URLSearchParams(location.search).get('token') ?? '';

/** The server's description of itself: `source`, `live`, `controls`. */
export async function about() {
  const answer = await fetch('/about?token=' + encodeURIComponent(token));
  if (!answer.ok) throw new Error('The server does not know this token: open the address that it printed');
  return answer.json();
}

/** Hands on the server's events, an array at a time; `lost` is called with true when it is gone, with false when it is back. */
export function follow(take, lost) {
  let stream;
  let next = 0;
  const open = () => {
    stream = new EventSource(`/events?token=${encodeURIComponent(token)}&from=${next}`);
    stream.onmessage = (message) => {
      next = Number(message.lastEventId) || next;
      take(JSON.parse(message.data));
    };
    stream.onopen = () => lost(false);
    stream.onerror = () => lost(true);
  };
  // A browser has six connections to a server at most: a page that nobody sees leaves its own to the others.
  document.addEventListener('visibilitychange', () => {
    stream?.close();
    if (!document.hidden) open();
  });
  if (!document.hidden) open();
}

/** What the server answers to a question: `answer`, its lines, or `error`. */
export async function post(path, body) {
  try {
    const answer = await fetch(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', 'X-Javino-Token': token },
      body: JSON.stringify(body),
    });
    return await answer.json();
  } catch {
    return { error: 'The server does not answer: has the run ended?' };
  }
}

/** Gives a command; the result is empty, or one line that says why it was refused. */
export async function command(body) {
  const { ok, error } = await post('/command', body);
  return ok === true ? '' : String(error ?? 'The server refused the command');
}

/** The events of a trace file, and the numbers of lines that are none. */
export async function read(file) {
  const events = [];
  const bad = [];
  (await file.text()).split('\n').forEach((line, i) => {
    if (line.trim() === '') return;
    try {
      events.push(JSON.parse(line));
    } catch {
      bad.push(i + 1);
    }
  });
  return { events, bad };
}
