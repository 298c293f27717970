package rasterlab.app.shell.labs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;

class LabModelTest {
    private final List<String> done = new ArrayList<>();
    private final LabModel<Object> lab =
            new LabModel<>(
                    this::made,
                    (model, kept) -> {},
                    model -> done.add("closed"),
                    Runnable::run,
                    kept -> done.add("brought back"));

    private Object made(Executor events) {
        done.add("made");
        events.execute(() -> done.add("answered"));
        return new Object();
    }

    @Test
    void modelIsMadeOnceWhenItIsAskedForAndHandsItsWorkOutWhenItIsAsItWasLeft() {
        lab.whenMade(model -> done.add("told"));
        assertEquals(List.of(), done);
        assertSame(lab.get(), lab.get());
        assertEquals(List.of("made", "brought back", "told", "answered"), done);
        lab.whenMade(model -> done.add("told later"));
        assertEquals("told later", done.get(4));
    }

    @Test
    void modelThatIsNotMadeKeepsNothingAndIsNotMadeToBeClosed() {
        assertEquals(Optional.empty(), lab.ifMade());
        assertEquals(Map.of(), lab.kept());
        lab.close();
        lab.prepare();
        assertEquals(List.of(), done);
        assertThrows(IllegalStateException.class, lab::get);
    }

    @Test
    void modelThatIsGivenUpIsNotMade() {
        lab.giveUp();
        lab.prepare();
        assertEquals(List.of(), done);
        assertThrows(IllegalStateException.class, lab::get);
    }

    @Test
    void whatAModelHandedOutThatCouldNotBeMadeIsNotDone() {
        var again =
                new LabModel<>(
                        this::madeAtSecond,
                        (model, kept) -> {},
                        model -> {},
                        Runnable::run,
                        kept -> {});
        assertThrows(IllegalArgumentException.class, again::get);
        again.get();
        assertEquals(List.of("first", "second", "answered by second"), done);
    }

    private Object madeAtSecond(Executor events) {
        String attempt = done.isEmpty() ? "first" : "second";
        done.add(attempt);
        events.execute(() -> done.add("answered by " + attempt));
        if (attempt.equals("first")) throw new IllegalArgumentException(attempt);
        return new Object();
    }

    @Test
    void madeModelIsClosed() {
        lab.prepare();
        lab.close();
        assertEquals("closed", done.get(done.size() - 1));
    }
}
