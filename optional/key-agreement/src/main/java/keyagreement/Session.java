package keyagreement;

/** A host's knowledge of the session key with a peer, as SPEC 11.3 has it; its inputs, and what follows. */
enum Session {
    NONE, SETTING, UNPROVEN, PROVEN;

    enum Input {
        VERIFIED, SET_FIRST, SET_SECOND, NOT_SET, SEALED, DELIVERED, UNDELIVERED, NO_KEY, FAILED,
        UNOPENED, BOOTED, FORGOTTEN
    }

    /** The message that was under way ends or goes again; or a handshake begins. */
    enum Deed {
        NOTHING, END, AGAIN, BEGIN
    }

    static final Table<Session, Input, Deed> TABLE = Table.of(Session.class, Input.class, Deed.class, """
                    NONE    SETTING  UNPROVEN   PROVEN
        VERIFIED    SETTING -s       SETTING    SETTING
        SET_FIRST   -n      UNPROVEN -n         -n
        SET_SECOND  -n      PROVEN   -n         -n
        NOT_SET     -n      NONE     -n         -n
        SEALED      -o      -o       PROVEN     .
        DELIVERED   .:END   .:END    PROVEN:END .:END
        UNDELIVERED .:AGAIN .:AGAIN  NONE:AGAIN UNPROVEN:END
        NO_KEY      .:AGAIN .:AGAIN  NONE:AGAIN NONE:AGAIN
        FAILED      .:END   .:END    .:END      .:END
        UNOPENED    .:BEGIN -s       NONE:BEGIN NONE:BEGIN
        BOOTED      .       -s       NONE       NONE
        FORGOTTEN   .       NONE     NONE       NONE
        """);
}
