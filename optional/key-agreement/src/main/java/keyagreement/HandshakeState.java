package keyagreement;

/** The states of a handshake, as SPEC 11.3 has them; what happens, and what it does or has its peer do. */
enum HandshakeState {
    WAITING, OPEN, ASKING, SETTING, CLOSING, CLOSED, ANSWERING, ANSWERED, DUE, OVER;

    enum Input {
        LATE, LACKING, SPENT, PART, VERIFIED, AGAIN, WANTED, ON_AIR, SET, UNOPENED, DONE
    }

    enum Deed {
        NOTHING, FIRST, SECOND, THIRD, WANT, ANEW, LATER, SAY, KEEP, IDLE, KEY, FAIL
    }

    static final Table<HandshakeState, Input, Deed> TABLE = Table.of(HandshakeState.class, Input.class, Deed.class, """
             WAITING    OPEN        ASKING      SETTING       CLOSING     CLOSED  ANSWERING     ANSWERED    DUE
    LATE     OPEN:FIRST .:FIRST     OPEN:FIRST  -s            OVER        OVER    OVER:FAIL     .:IDLE      ANSWERED:SAY
    LACKING  OPEN:FIRST ASKING:WANT OPEN:FIRST  -s            OVER        OVER    OVER:FAIL     .:WANT      ANSWERED:SAY
    SPENT    OVER:FAIL  OVER:FAIL   OVER:FAIL   -s            OVER        OVER    OVER:FAIL     OVER:FAIL   ANSWERED:SAY
    PART     -n         .           OPEN        -s            -n          -n      -p            -p          -p
    VERIFIED -n         SETTING:KEY SETTING:KEY -s            -n          -n      SETTING:KEY   SETTING:KEY SETTING:KEY
    AGAIN    -r         -r          -r          -s            -r          -r      -b            DUE:LATER   .:LATER
    WANTED   -n         -n          -n          -s            .:THIRD     .:THIRD -b            DUE:LATER   .:LATER
    ON_AIR   -n         -n          -n          -s            CLOSED:KEEP .:KEEP  ANSWERED:KEEP .:KEEP      .:KEEP
    SET      -n         -n          -n          CLOSING:THIRD -n          -n      -r            -r          -r
    UNOPENED .:ANEW     .:ANEW      .:ANEW      -s            OVER        OVER    -b            .:WANT      -b
    DONE     -n         -n          -n          OVER          OVER        OVER    -r            -r          -r
    """);
}
