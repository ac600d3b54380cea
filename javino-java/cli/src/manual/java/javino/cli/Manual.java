package javino.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.codegen.docgen.manpage.ManPageGenerator;

/** Writes what a package of the {@code javino} command has beside it. */
final class Manual {

    private Manual() {}

    /**
     * Writes bash's completion, {@code javino}, and a page of the manual for each command, {@code javino*.adoc}, in
     * AsciiDoc.
     *
     * @param args the folder
     */
    public static void main(String[] args) throws IOException {
        CommandLine javino = Main.commandLine(PortOption.serial());
        Path folder = Files.createDirectories(Path.of(args[0]));
        Files.writeString(folder.resolve("javino"), AutoComplete.bash("javino", javino));
        System.exit(ManPageGenerator.generateManPage(folder.toFile(), null, new boolean[0], false,
                javino.getCommandSpec()));
    }
}
