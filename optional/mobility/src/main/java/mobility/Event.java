package mobility;

import diffuser.report.Failure;

/** An event of a move: a message of the other side, or something on this one. */
sealed interface Event permits MoveMessage.Said, Event.Delivered, Event.Undelivered, Event.NotTaken, Event.Accepted,
        Event.Rejected, Event.Woken, Event.Superseded, Event.Expired {

    /** The message that is said has come. */
    record Delivered() implements Event {
    }

    /** It was not acknowledged. */
    record Undelivered() implements Event {
    }

    /** The board here does not send it. */
    record NotTaken(Failure why) implements Event {
    }

    /** A plan lets the agent in, or its texts are here and right. */
    record Accepted() implements Event {
    }

    /** @param again whether a part was not what was offered, and is here no longer. */
    record Rejected(RefusedException why, boolean again) implements Event {
    }

    /**
     * The agent has got a name, and does nothing yet.
     *
     * @param anew whether it was awake here before this computer started.
     */
    record Woken(String name, boolean anew) implements Event {
    }

    /** Another move has taken the agent on, or back; or it has ended. */
    record Superseded() implements Event {
    }

    /** Nothing has come for {@link Machine#patience}, or enough others have left since. */
    record Expired() implements Event {
    }
}
