package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** CMake refuses to build on a folder that it has built before its clone was moved or copied. */
@Tag("verify")
class MovedCloneTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));

    @ParameterizedTest
    @ValueSource(strings = {"mv", "cp -a"})
    void folder_ofAnotherPlace_isMadeAnew(String how, @TempDir Path folder) throws Exception {
        Path before = Files.createDirectory(folder.resolve("before"));
        Path clone = folder.resolve("my clone");
        Files.writeString(before.resolve("CMakeLists.txt"), """
                cmake_minimum_required(VERSION 3.16)
                project(place NONE)
                add_custom_target(place ALL ${CMAKE_COMMAND} -E touch ${CMAKE_CURRENT_BINARY_DIR}/made)
                """);
        Files.writeString(before.resolve("settings.gradle"), "rootProject.name = 'place'\n");
        Files.writeString(before.resolve("build.gradle"), """
                apply from: '%s/gradle/cmake.gradle'
                task configure(type: Exec) { configures(it, projectDir, file('build')) }
                task make(type: Exec, dependsOn: configure) { builds(it, file('build')) }
                """.formatted(ROOT));
        for (String build : List.of("build", "build/other")) {
            Release.run("cmake", "-S", before.toString(), "-B", before.resolve(build).toString());
            Files.writeString(before.resolve(build).resolve("stale"), "");
        }
        Release.run("sh", "-c", how + " '" + before + "' '" + clone + "'");

        assertEquals(0, NewProjectTest.gradle("make").directory(clone.toFile()).inheritIO().start().waitFor());
        assertTrue(Files.exists(clone.resolve("build/made")));
        assertFalse(Files.exists(clone.resolve("build/stale")));
        assertTrue(Files.exists(clone.resolve("build/other/stale")), "another folder has its own task");

        // Files of this place stay.
        Files.writeString(clone.resolve("build/kept"), "");
        assertEquals(0, NewProjectTest.gradle("make", "--rerun-tasks").directory(clone.toFile()).inheritIO().start()
                .waitFor());
        assertTrue(Files.exists(clone.resolve("build/kept")));
    }

    /** A task that called CMake by itself would fail in a clone that was moved. */
    @Test
    void cmake_isCalledInOnePlace() throws Exception {
        Process git = new ProcessBuilder("git", "-C", ROOT.toString(), "grep", "-l", "-w", "-E", "cmake -S|'cmake'",
                "--", "*.gradle").start();
        assertEquals(List.of("gradle/cmake.gradle"), git.inputReader().lines().toList());
    }
}
