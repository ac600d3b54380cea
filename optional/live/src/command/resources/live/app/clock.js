// The moment that is shown: it follows the run, or is played forwards and backwards.

/** Behind the newest event, in emulated seconds: a packet is known only when it has ended, and is drawn from its start. */
const LAG = 0.6;
/** Farther behind than this, the clock jumps. */
const JUMP = 3;

export class Clock {
  t = 0;
  rate = 1;
  playing = true;
  #heardAt = 0;
  #heard = -1;
  #before;

  constructor(live) {
    this.live = live;
    this.following = live;
  }

  /** Goes on to this moment of the wall clock (ms). `ended`: no more events will come. */
  tick(now, model, ended) {
    const passed = Math.min((now - (this.#before ?? now)) / 1000, 0.25);
    this.#before = now;
    if (this.following) this.#follow(now, passed, model, ended);
    else if (this.playing) this.seek(this.t + passed * this.rate, model);
  }

  #follow(now, passed, model, ended) {
    const speed = model.head.speed;
    if (model.end > this.#heard) [this.#heard, this.#heardAt] = [model.end, now];
    const stopped = ended || speed === 0;
    // While nothing happens, no event tells the time.
    const end = stopped ? model.end : model.end + ((now - this.#heardAt) / 1000) * Math.min(speed, 1);
    const aim = stopped ? end : end - LAG;
    const behind = aim - this.t;
    if (behind > JUMP * Math.max(1, speed) || behind < -JUMP) this.t = Math.max(0, aim);
    else this.t = Math.min(stopped ? end : Infinity, this.t + passed * (speed || 1) * (1 + Math.max(-0.9, Math.min(3, behind))));
  }

  seek(t, model) {
    this.t = Math.max(0, Math.min(t, model.end));
    // At either end a player has nothing more to do.
    if (!this.playing || model.end === 0) return;
    if (this.t === model.end && this.rate > 0 && this.live) this.follow();
    else if (this.t === (this.rate < 0 ? 0 : model.end)) this.playing = false;
  }

  /** Leaves the end of the run, to look at another moment. */
  leave(t, model) {
    this.following = false;
    this.playing = false;
    this.seek(t, model);
  }

  toggle(model) {
    if (this.following) {
      this.leave(this.t, model);
    } else {
      this.playing = !this.playing;
      if (this.playing && this.rate > 0 && this.t >= model.end) this.t = 0;
    }
  }

  follow() {
    this.following = this.live;
    this.playing = true;
    this.rate = Math.abs(this.rate);
  }
}
