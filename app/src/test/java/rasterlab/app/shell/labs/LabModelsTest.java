package rasterlab.app.shell.labs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LabModelsTest {
    private final List<String> begun = new ArrayList<>();
    private final LabModels models =
            LabModels.unmade(
                    work -> {},
                    labs -> begun.addAll(labs.keySet()),
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void close() {
        models.close();
    }

    @Test
    void tabNeedsItsOwnLabAlone() {
        models.make("line");
        assertEquals(List.of("line", "line.tried", "line.figures", "line.mode"), begun);
        assertEquals(Set.copyOf(begun), models.kept().keySet());
        assertEquals(Set.copyOf(begun), models.asMade().keySet());
    }

    @Test
    void windowThatOpensOnATabThatThereIsNotNeedsTheFirst() {
        models.make("none");
        assertEquals("coordinates", begun.get(0));
    }

    @ParameterizedTest(name = "{0} opens no sooner than the labs that it has ways into")
    @ValueSource(strings = {"study", "exercises"})
    void tabWithWaysIntoOthersWaitsForNone(String tab) {
        models.make(tab);
        assertEquals(Set.of(tab), Set.copyOf(begun));
    }

    @Test
    void windowClosedWhileItsLabsAreMadeWaitsForNoFurtherOne() {
        var closed = new AtomicReference<LabModels>();
        LabModels closing =
                LabModels.unmade(
                        work -> {},
                        labs -> {
                            begun.addAll(labs.keySet());
                            closed.get().close();
                        },
                        failure -> {
                            throw new AssertionError(failure);
                        });
        closed.set(closing);
        closing.makeAll();
        closing.close();
        assertEquals("coordinates", begun.get(0));
        assertFalse(begun.contains("line"), begun.toString());
    }
}
