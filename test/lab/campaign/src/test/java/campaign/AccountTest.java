package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The account of two hosts' logs. */
class AccountTest {

    @TempDir
    private Path folder;

    @Test
    void of_deliveredAndReceived_isWell() throws IOException {
        assertEquals(new Account(2, 1, 0, 0, 0, 0, 0),
                account("run\noffered 0\noffered 1\nended 0 DELIVERED\nended 1 UNDELIVERED\nend\n",
                        "run\nreceived 0 17\nreceived 1 18\nend\n"));
    }

    @Test
    void of_deliveredAndNotReceived_isLost() throws IOException {
        assertEquals(1, account("run\noffered 0\nended 0 DELIVERED\n", "run\n").lost());
    }

    @Test
    void of_sameIdInTheNextRun_isAgain() throws IOException {
        Account account = account("run\noffered 0\n", "run\nreceived 0 17\nrun\nreceived 0 17\n");
        assertEquals(1, account.redelivered());
        assertEquals(0, account.twice());
    }

    @Test
    void of_anotherIdInTheNextRun_isTwice() throws IOException {
        assertEquals(1, account("run\noffered 0\n", "run\nreceived 0 17\nrun\nreceived 0 18\n").twice());
    }

    @Test
    void of_sameRun_isTwice() throws IOException {
        assertEquals(1, account("run\noffered 0\n", "run\nreceived 0 17\nreceived 0 17\n").twice());
    }

    @Test
    void of_neverOffered_isWrong() throws IOException {
        assertEquals(2, account("run\noffered 0\n", "run\nreceived 1 17\nwrong something\n").wrong());
    }

    @Test
    void of_hostThatWaitedInVain_isStuck() throws IOException {
        assertEquals(2, account("run\noffered 0\nstuck 2\nend\n", "run\n").stuck());
    }

    private Account account(String sender, String receiver) throws IOException {
        Path one = Files.writeString(folder.resolve("sender"), sender);
        Path two = Files.writeString(folder.resolve("receiver"), receiver);
        return Account.of(new HostLog(one), new HostLog(two));
    }
}
