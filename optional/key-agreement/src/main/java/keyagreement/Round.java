package keyagreement;

import javino.protocol.HostMessage.Kind;

/** The two ways to agree on a key. */
enum Round {
    /** By certificates. */
    FULL(Kind.MESSAGE_1, Kind.MESSAGE_2, Kind.MESSAGE_3, 1200, 1400),
    /** By the secret that both have kept. */
    RENEWAL(Kind.RENEWAL_1, Kind.RENEWAL_2, Kind.RENEWAL_3, 800, 1000);

    final Kind first;
    final Kind second;
    final Kind third;
    /** How long message 2 and message 3 are awaited. */
    final int secondMillis;
    final int thirdMillis;

    Round(Kind first, Kind second, Kind third, int secondMillis, int thirdMillis) {
        this.first = first;
        this.second = second;
        this.third = third;
        this.secondMillis = secondMillis;
        this.thirdMillis = thirdMillis;
    }
}
