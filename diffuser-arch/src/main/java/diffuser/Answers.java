package diffuser;

import jason.JasonException;
import jason.asSemantics.Message;

/** Sends what the agent's plans answer to other devices' questions. */
final class Answers {

    private final Outbox outbox;

    Answers(Outbox outbox) {
        this.outbox = outbox;
    }

    /**
     * Sends an answer. Where a group was asked, those who know nothing keep silent: their answers would fill the air.
     *
     * @throws JasonException if it cannot be sent; the asker is told so, as it would else wait for it.
     */
    void send(Message answer, Enquiry enquiry, Device board) throws JasonException {
        try {
            Letter letter = Letter.answer(answer, enquiry.conversation());
            if (!enquiry.ofGroup() || !letter.knowsNothing()) {
                outbox.post(letter, board);
            }
        } catch (JasonException e) {
            outbox.post(Letter.sorry(answer, enquiry.conversation(), Failure.of(e)), board);
            throw e;
        }
    }
}
