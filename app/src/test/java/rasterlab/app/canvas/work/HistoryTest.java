package rasterlab.app.canvas.work;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HistoryTest {
    private String shown = "a";
    private final History<String> history = new History<>(() -> shown, next -> shown = next);

    /** A letter is a change to it, inside ( ) as part of a drag; - takes back, + makes again. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "undo goes back too far, bc-, b, true, true",
        "redo is lost after several undos, bcd---++, c, true, true",
        "redo goes beyond the newest change, bc--++++, c, true, false",
        "a new change keeps what was taken back, bc-d+, d, true, false",
        "a new change after all undos keeps what was taken back, b-c, c, true, false",
        "each move of a drag is a change of its own, (bcd)-, a, false, true",
        "redo brings back part of a drag, (bcd)-+, d, true, false",
        "a drag that changed nothing can be undone, (bca), a, false, false",
        "a drag that changed nothing drops redo, bc-(db)+, c, true, false",
        "a drag that changed something keeps redo, bc-(bd)+, d, true, false",
        "redo is offered within a drag, bc-(d, d, true, false",
        "undo within a drag goes beyond its start, b(cd-, b, true, false",
        "what is dragged after an undo within the drag is forgotten, b(cd-e)-, b, true, true",
    })
    void changes(String mistake, String commands, String end, boolean undoable, boolean redoable) {
        commands.chars().forEach(this::command);
        assertEquals(
                List.of(end, undoable, redoable),
                List.of(shown, history.undoable(), history.redoable()),
                mistake);
    }

    private void command(int each) {
        switch (each) {
            case '(' -> history.beginDrag();
            case ')' -> history.endDrag();
            case '-' -> history.undo();
            case '+' -> history.redo();
            default -> {
                history.remember();
                shown = Character.toString(each);
            }
        }
    }
}
