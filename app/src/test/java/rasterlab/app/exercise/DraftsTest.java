package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.outcome.Pipe;

class DraftsTest {
    private static final String ID = "line-bresenham";

    @TempDir Path folder;
    private final List<Drafts.Saving> told = new CopyOnWriteArrayList<>();

    private Drafts opened() {
        return opened("java");
    }

    private Drafts opened(String ending) {
        return new Drafts(folder.resolve("drafts"), exercise -> ending, told::add);
    }

    private Path file(String name) {
        return folder.resolve("drafts").resolve(name);
    }

    @Test
    void whatWasTypedLastIsThereAgain() {
        try (Drafts first = opened()) {
            assertEquals(Optional.empty(), first.open(ID));
            first.save(ID, "class A {}");
            first.save(ID, "class Á {}");
        }
        try (Drafts again = opened()) {
            assertEquals(Optional.of("class Á {}"), again.open(ID));
        }
        assertEquals("", told.get(told.size() - 1).problem());
    }

    @Test
    void inputsAreKeptAsJson() throws Exception {
        try (Drafts drafts = opened("json")) {
            assertEquals(Optional.empty(), drafts.open("break-line"));
            drafts.save("break-line", "[]");
            drafts.settle();
            assertEquals(Optional.of(file("break-line.json")), drafts.path("break-line"));
        }
        assertEquals("[]", Files.readString(file("break-line.json")));
    }

    @Test
    void inputsOfAnEarlierVersionAreFoundAndNamedAnew() throws Exception {
        try (Drafts earlier = opened("java")) {
            earlier.open("break-line");
            earlier.save("break-line", "[1]");
        }
        try (Drafts drafts = opened("json")) {
            assertEquals(Optional.of("[1]"), drafts.open("break-line"));
        }
        assertEquals("[1]", Files.readString(file("break-line.json")));
        assertFalse(Files.exists(file("break-line.java")), "a second copy is left behind");
    }

    @Test
    void pipeIsPassedOver() throws Exception {
        Files.createDirectories(folder.resolve("drafts"));
        Pipe.at(file(ID + ".java"));
        try (Drafts drafts = opened()) {
            assertEquals(Optional.empty(), drafts.open(ID));
            drafts.save(ID, "typed");
            drafts.settle();
            assertEquals("typed", Files.readString(file(ID + ".2.java")));
        }
    }

    @Test
    void textIsOnTheDiskBeforeTheWindowIsClosed() throws Exception {
        try (Drafts drafts = opened()) {
            drafts.open(ID);
            drafts.save(ID, "typed");
            drafts.settle();
            assertEquals("typed", Files.readString(file(ID + ".java")));
        }
    }

    @Test
    void changesOfSeveralExercisesAreAllWritten() throws IOException {
        try (Drafts drafts = opened()) {
            for (int i = 0; i < 50; i++) {
                drafts.save(ID, "a" + i);
                drafts.save("other", "b" + i);
            }
        }
        assertEquals("a49", Files.readString(file(ID + ".java")));
        assertEquals("b49", Files.readString(file("other.java")));
    }

    @Test
    void secondWindowBeginsWithTheFirstOnesTextAndWritesAFileOfItsOwn() throws Exception {
        try (Drafts first = opened();
                Drafts second = opened()) {
            first.open(ID);
            first.save(ID, "of the first");
            first.settle();
            assertEquals(Optional.of("of the first"), second.open(ID));
            second.save(ID, "of the second");
            second.settle();
            first.save(ID, "of the first, later");
            first.settle();
            assertEquals("of the first, later", Files.readString(file(ID + ".java")));
            assertEquals("of the second", Files.readString(file(ID + ".2.java")));
            assertEquals("of the second", first.others(ID).get(0).text());
            assertEquals("of the first, later", second.others(ID).get(0).text());
        }
    }

    @Test
    void fileThatIsNoTextIsNotWrittenOver() throws Exception {
        byte[] broken = {(byte) 0xC3, (byte) 0x28};
        Files.createDirectories(folder.resolve("drafts"));
        Files.write(file(ID + ".java"), broken);
        try (Drafts drafts = opened()) {
            assertEquals(Optional.empty(), drafts.open(ID));
            drafts.save(ID, "new");
        }
        assertArrayEquals(broken, Files.readAllBytes(file(ID + ".java")));
        assertEquals("new", Files.readString(file(ID + ".2.java")));
    }

    @Test
    void folderThatCannotBeMadeIsToldAndTriedAgainWithTheNextChange() throws Exception {
        Files.writeString(folder.resolve("drafts"), "a file in the way");
        try (Drafts drafts = opened()) {
            assertEquals(Optional.empty(), drafts.open(ID));
            drafts.save(ID, "typed");
            drafts.settle();
            String problem = told.get(told.size() - 1).problem();
            assertTrue(problem.contains(folder.resolve("drafts").toString()), problem);
            Files.delete(folder.resolve("drafts"));
            drafts.save(ID, "typed on");
            drafts.settle();
            assertEquals("", told.get(told.size() - 1).problem());
            assertEquals("typed on", Files.readString(file(ID + ".java")));
        }
    }

    @Test
    void everyFileIsLetGoThoughTheFirstCannotBe() {
        List<String> closed = new ArrayList<>();
        List<Closeable> files =
                List.of(failing("first"), () -> closed.add("second"), failing("third"));
        var told = assertThrows(UncheckedIOException.class, () -> Drafts.closeAll(files));
        assertEquals(List.of("second"), closed);
        assertEquals("first", told.getCause().getMessage());
        assertEquals("third", told.getCause().getSuppressed()[0].getMessage());
    }

    private static Closeable failing(String why) {
        return () -> {
            throw new IOException(why);
        };
    }
}
