package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.Closing.ClosingDecision.CLOSE_ANYWAY;
import static rasterlab.app.exercise.Closing.ClosingDecision.SAVE_ELSEWHERE;
import static rasterlab.app.exercise.Closing.ClosingDecision.STAY;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ClosingTest {
    private static final UnsavedDraft LINE = new UnsavedDraft("line", "of lines", "no folder");
    private static final UnsavedDraft FILL = new UnsavedDraft("fill", "of fills", "no folder");

    @TempDir Path folder;
    private final Deque<Closing.ClosingDecision> answers = new ArrayDeque<>();
    private final Deque<Optional<Path>> places = new ArrayDeque<>();
    private final List<List<UnsavedDraft>> asked = new ArrayList<>();
    private final List<String> told = new ArrayList<>();

    private boolean allowed(UnsavedDraft... unsaved) {
        return Closing.allowed(
                List.of(unsaved),
                new Closing.User() {
                    @Override
                    public Closing.ClosingDecision answer(List<UnsavedDraft> left) {
                        asked.add(left);
                        return answers.removeFirst();
                    }

                    @Override
                    public Optional<Path> place(UnsavedDraft draft) {
                        return places.removeFirst();
                    }

                    @Override
                    public void tell(String problem) {
                        told.add(problem);
                    }
                });
    }

    @Test
    void nobodyIsAskedWhereAllIsSaved() {
        assertTrue(allowed());
        assertEquals(List.of(), asked);
    }

    @Test
    void whoStaysKeepsTheWindow() {
        answers.add(STAY);
        assertFalse(allowed(LINE));
    }

    @Test
    void whoClosesAnywayLosesTheText() {
        answers.add(CLOSE_ANYWAY);
        assertTrue(allowed(LINE));
    }

    @Test
    void eachTextIsWrittenWhereTheUserWantsIt() throws IOException {
        answers.add(SAVE_ELSEWHERE);
        places.add(Optional.of(folder.resolve("a.java")));
        places.add(Optional.of(folder.resolve("b.java")));
        assertTrue(allowed(LINE, FILL));
        assertEquals("of lines", Files.readString(folder.resolve("a.java")));
        assertEquals("of fills", Files.readString(folder.resolve("b.java")));
    }

    @Test
    void placeThatTakesNothingIsToldAndTheUserIsAskedAgain() throws IOException {
        Path inTheWay = Files.writeString(folder.resolve("file"), "in the way");
        answers.addAll(List.of(SAVE_ELSEWHERE, SAVE_ELSEWHERE, STAY));
        places.add(Optional.of(inTheWay.resolve("a.java")));
        places.add(Optional.of(folder.resolve("b.java")));
        places.add(Optional.empty());
        assertFalse(allowed(LINE, FILL));
        assertEquals(List.of(List.of(LINE, FILL), List.of(LINE), List.of(LINE)), asked);
        assertTrue(told.get(0).contains("a.java"), told.toString());
        assertEquals(1, told.size());
        assertEquals("of fills", Files.readString(folder.resolve("b.java")));
    }
}
