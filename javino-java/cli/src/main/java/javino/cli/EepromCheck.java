package javino.cli;

import javino.keyring.SharedKey;
import java.util.List;
import java.util.Map;
import javino.board.LostState;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Reply.Role;
import javino.protocol.Reply.StoredKey;

/** Examines what a board has in its EEPROM: RF id, keys, epoch. */
final class EepromCheck {

    private final String port;
    private final Findings findings;

    /** @param port for the remedies. */
    EepromCheck(String port, Findings findings) {
        this.port = port;
        this.findings = findings;
    }

    /** @param wanted null where any will do. */
    void examineId(BoardInfo info, Address wanted) {
        if (info.rfId().isEmpty()) {
            findings.trouble("RF id", "none; " + provision(wanted));
        } else if (wanted != null && !info.rfId().get().equals(wanted)) {
            findings.trouble("RF id", info.rfId().get() + " instead of " + wanted + "; another board, or "
                    + provision(wanted));
        } else {
            findings.ok("RF id", info.rfId().get());
        }
    }

    /** @param wanted none where any will do. */
    void examineKeys(List<StoredKey> stored, Map<Address, SharedKey> wanted, Address id) {
        List<StoredKey> current = stored.stream().filter(key -> key.role() == Role.CURRENT).toList();
        if (wanted.isEmpty() && current.isEmpty()) {
            findings.trouble("keys", "none, so that only broadcasts are sent and heard; javino keygen once, and "
                    + provision(id));
        } else if (wanted.isEmpty()) {
            findings.ok("keys", current.size());
        }
        wanted.forEach((address, key) -> examineKey(address, current.stream()
                .filter(each -> each.address().equals(address)).map(StoredKey::check).findFirst().orElse(null),
                key, id));
        LostState.ofFloors(stored).ifPresent(what -> findings.trouble("floors", what));
    }

    private void examineKey(Address address, Bytes found, SharedKey expected, Address id) {
        String what = "key " + address;
        if (found == null) {
            findings.trouble(what, "missing; " + provision(id));
        } else if (expected.all().stream().noneMatch(key -> key.check().equals(found))) {
            findings.trouble(what, "another than in the keyring: check value " + found + " instead of "
                    + expected.key().check() + "; " + provision(id));
        } else {
            findings.ok(what, "check value " + found);
        }
    }

    /** @param noted an epoch that the board of this id has had; 0 where none is known. */
    void examineNonces(BoardInfo info, int noted, Address id) {
        if (info.hasLostEpoch()) {
            findings.trouble("nonces", LostState.notRaised() + ": " + provision(id));
        } else if (info.bootEpoch() < noted) {
            findings.trouble("nonces", "epoch " + info.bootEpoch() + ", but the keyring notes " + noted + " of "
                    + id + ": what it seals is refused; " + provision(id));
        } else if (info.bootEpoch() > BoardInfo.LAST_EPOCH) {
            findings.trouble("nonces", "the epochs are used up; another board, with new keys");
        } else {
            findings.ok("nonces", "epoch " + info.bootEpoch() + " of " + BoardInfo.LAST_EPOCH);
        }
    }

    private String provision(Address id) {
        return "javino provision --port " + port + " --id " + (id == null ? "ADDRESS" : id)
                + " --keyring FILE";
    }
}
