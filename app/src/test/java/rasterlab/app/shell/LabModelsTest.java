package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

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
        assertEquals(List.of("line", "line.figures", "line.mode"), begun);
        assertEquals(Set.copyOf(begun), models.kept().keySet());
        assertEquals(Set.copyOf(begun), models.asMade().keySet());
    }

    @Test
    void windowThatOpensOnATabThatThereIsNotNeedsTheFirst() {
        models.make("none");
        assertEquals("coordinates", begun.get(0));
    }

    @Test
    void tabWithWaysIntoOthersNeedsThemAll() {
        models.make("study");
        int all = begun.size();
        models.makeAll();
        assertEquals(all, begun.size());
        assertEquals(Set.copyOf(begun), models.kept().keySet());
    }
}
