package simulation;

import java.util.Map;

import diffuser.HostService;

import javino.protocol.Address;

/** What a host runs; it is called within steps of the host. */
public interface Program extends HostService {

    /** The host has started, and has nothing of before but what is on its disk. */
    void started();

    /** A sealed packet has come for which the board has no key. */
    default void noKey(Address from) {
    }

    /** The board has booted. */
    default void booted() {
    }

    /** A step of the host is done. */
    default void stepped() {
    }

    @Override
    default Map<String, Object> status() {
        return Map.of();
    }

    /** The host is killed. */
    @Override
    default void stop() {
    }
}
