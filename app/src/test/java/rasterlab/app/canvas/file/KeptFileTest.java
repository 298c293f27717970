package rasterlab.app.canvas.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** A lab of texts: a file holds its own name, and a name with "!" is that of a broken one. */
class KeptFileTest {
    private static final String OWN = "own";

    private final List<Supplier<Runnable>> readings = new ArrayList<>();
    private final Texts lab = new Texts();
    private final KeptFile<String, String, String> files = new KeptFile<>(lab, readings::add);

    private static final class Texts implements KeptFile.FileLab<String, String, String> {
        private String shown = OWN;
        private String told = "";

        @Override
        public Class<String> keptType() {
            return String.class;
        }

        @Override
        public String shown() {
            return shown;
        }

        @Override
        public String files(String now) {
            return now.equals(OWN) ? "" : now;
        }

        @Override
        public Object place(String now) {
            return now;
        }

        @Override
        public Optional<Supplier<String>> reading(String kept, String before) {
            return kept.isEmpty() ? Optional.empty() : Optional.of(() -> kept);
        }

        @Override
        public boolean open(String read) {
            told = failureText(read, "");
            return told.isEmpty();
        }

        @Override
        public String restore(String kept, String read) {
            return failureText(read, ", own instead");
        }

        private String failureText(String read, String instead) {
            if (read.endsWith("!")) return read + " is broken" + instead;
            shown = read;
            return "";
        }

        @Override
        public String remark() {
            return told;
        }

        @Override
        public void tell(String problem) {
            told = problem;
        }
    }

    private void open(String file) {
        files.open(() -> file);
    }

    /** The answer of a reading, by the order in which they were asked for. */
    private void answer(int number) {
        readings.get(number).get().run();
    }

    private void assertShown(String file, String told) {
        assertEquals(file, lab.shown);
        assertEquals(told, lab.told);
    }

    @Test
    @DisplayName("a file opened while a broken one was read is lost for the one that comes back")
    void newestFileStays() {
        files.restore("kept");
        open("first!");
        open("second");
        answer(1);
        assertEquals(3, readings.size(), "a reading after the user's newest");
        answer(2);
        assertShown("second", "");
        assertEquals(3, readings.size());
        assertEquals("second", files.kept());
    }

    @Test
    @DisplayName("a broken file opened meanwhile costs the one that is coming back, unsaid")
    void comesBackAfterABrokenFile() {
        files.restore("kept");
        open("broken!");
        answer(1);
        assertShown(OWN, "broken! is broken");
        assertEquals("kept", files.kept(), "closed too soon");
        answer(2);
        assertShown("kept", "broken! is broken");
    }

    @Test
    @DisplayName("what is wrong with the user's file, or the kept one, is told only for a moment")
    void bothProblemsAreTold() {
        files.restore("gone!");
        open("broken!");
        answer(1);
        answer(2);
        assertShown(OWN, "broken! is broken; besides, gone! is broken, own instead");
        assertEquals("", files.kept(), "asked for at every start");
    }

    @Test
    @DisplayName("what is read late is told or shown before the file that the user has opened")
    void comesBackAfterTheUsersFile() {
        files.restore("kept");
        open("broken!");
        answer(0);
        assertShown(OWN, "");
        answer(1);
        answer(2);
        assertShown("kept", "broken! is broken");
    }

    @Test
    @DisplayName("a file takes the place of one that the user opened, or comes back without it")
    void isForgottenOnceAnotherIsShown() {
        files.restore("kept");
        open("good");
        answer(1);
        lab.shown = OWN;
        answer(0);
        assertShown(OWN, "");
        open("broken!");
        answer(2);
        assertEquals(3, readings.size(), "read again");
    }

    @Test
    @DisplayName("a file takes the place of what was chosen meanwhile")
    void choiceMeanwhileStays() {
        files.restore("kept");
        lab.shown = "globe";
        answer(0);
        assertShown("globe", "");
    }

    @Test
    @DisplayName("what an earlier run showed stops the reading of what the user opened")
    void waitsForTheUsersFile() {
        open("broken!");
        files.restore("kept");
        assertEquals(1, readings.size());
        answer(0);
        answer(1);
        assertShown("kept", "broken! is broken");
    }
}
