package rasterlab.app.coordinates.turn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.EventQueue;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JSpinner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.Parts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class TurnInspectorTest {
    private final List<Throwable> failures = new ArrayList<>();

    @Test
    @DisplayName("half a turn is rounded without a word")
    void turnsAreCounted() throws Exception {
        try (var model = new TurnLabModel(Runnable::run, failures::add)) {
            EventQueue.invokeAndWait(
                    () -> {
                        var texts = Texts.of("coordinates.turn", Language.ENGLISH);
                        var inspector = new TurnInspector(model, texts, column -> {});
                        var times =
                                (JSpinner)
                                        Parts.of(inspector.column())
                                                .filter(c -> "times.field".equals(c.getName()))
                                                .findFirst()
                                                .orElseThrow();
                        ((JSpinner.DefaultEditor) times.getEditor()).getTextField().setText("2.5");
                        assertThrows(ParseException.class, times::commitEdit);
                    });
        }
        assertEquals(List.of(), failures);
    }
}
