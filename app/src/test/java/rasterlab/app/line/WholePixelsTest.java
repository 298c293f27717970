package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.EventQueue;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JSpinner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.trace.LineMode;
import rasterlab.engine.line.LineTopic;

class WholePixelsTest {
    private final List<Throwable> failures = new ArrayList<>();
    private final Texts texts = Texts.of("line", Language.ENGLISH);

    @Test
    @DisplayName("a centre or a half-axis between pixels is rounded without a word")
    void figureIsOnWholePixels() throws Exception {
        try (var model = new FigureLabModel(Runnable::run, failures::add)) {
            EventQueue.invokeAndWait(
                    () -> {
                        model.chooseMode(LineMode.CIRCLE);
                        var fields = new ArcFields(model, texts);
                        refuses((JSpinner) fields.center().getComponent(1));
                        refuses((JSpinner) fields.radii().getComponent(0));
                    });
        }
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("an end between pixels is rounded without a word")
    void endIsOnWholePixels() throws Exception {
        try (var model = new LineLabModel(new LineTopic(), Runnable::run, failures::add)) {
            EventQueue.invokeAndWait(
                    () -> refuses((JSpinner) new EndFields(End.A, model, texts).getComponent(0)));
        }
        assertEquals(List.of(), failures);
    }

    private static void refuses(JSpinner field) {
        Object before = field.getValue();
        ((JSpinner.DefaultEditor) field.getEditor()).getTextField().setText("3.7");
        assertThrows(ParseException.class, field::commitEdit);
        assertEquals(before, field.getValue());
    }
}
