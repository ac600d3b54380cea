package javino.keyring;

import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;

class DeviceNotesTest {

    /** Notes about emulated boards would stand among the user's. */
    @Test
    void named_inTests_isNotTheUsersFolder() {
        assertNotEquals(DeviceNotes.defaultFolder(), DeviceNotes.named().folder());
    }
}
