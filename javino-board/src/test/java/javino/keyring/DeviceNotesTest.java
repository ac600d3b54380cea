package javino.keyring;

import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;

class DeviceNotesTest {

    /** What emulated boards have would be noted of the user's. */
    @Test
    void named_inTests_isNotTheUsersFolder() {
        assertNotEquals(DeviceNotes.defaultFolder(), DeviceNotes.named().folder());
    }
}
