package gateway;

import java.util.concurrent.CompletionStage;
import javino.JavinoException;
import javino.protocol.Bytes;
import javino.protocol.Frame;

/** The radio by which a gateway hears and reaches its cell. */
interface Radio extends AutoCloseable {

    boolean isOnline();

    /** For how many ms its own airtime limit holds back what is new; 0: not at all, or there is none. */
    default long airtimeWait() {
        return 0;
    }

    /** Sends a frame, one at a time; tells whether it was on the air. */
    CompletionStage<Boolean> relay(Frame frame);

    @Override
    void close();

    /** Told what happens, on a thread of the radio. */
    interface Listener {

        /** It is there. @param firmware the firmware of its board. */
        void online(String firmware);

        /** It has gone, and comes again by itself. */
        void offline(String why);

        /** It has heard a packet. */
        void heard(Bytes packet);

        /** It has heard one that is damaged beyond correction. */
        void damaged();
    }

    /** Knows where a radio is. */
    interface Opener {

        /**
         * Waits until it hears.
         *
         * @throws JavinoException if it is not there, or cannot do what is needed.
         */
        Radio open(Listener listener) throws JavinoException, InterruptedException;
    }
}
