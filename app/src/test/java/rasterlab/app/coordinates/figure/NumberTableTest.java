package rasterlab.app.coordinates.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;

class NumberTableTest {
    private final AtomicReference<NumberTable> made = new AtomicReference<>();
    private final JPanel column = new JPanel(new BorderLayout());

    @BeforeEach
    void make() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    made.set(new NumberTable("numbers", "numbers"));
                    List<String> row = List.of("buneman-textbook", "rounding", "(-5.43, -6.6)");
                    made.get().show(List.of("method", "error", "point"), List.of(row, row), 1);
                    column.add(made.get());
                });
    }

    private float sizeIn(int width) throws Exception {
        OffscreenPainter.paint(column, width, 200);
        assertTrue(made.get().needed() <= width, made.get().needed() + " in " + width);
        return made.get().getFont().getSize2D();
    }

    @Test
    void numbersAreNotCutInANarrowColumn() throws Exception {
        float wide = sizeIn(600);
        float needed = made.get().needed();
        assertTrue(sizeIn((int) (needed * 0.8)) < wide, "the type is as large as before");
        assertEquals(wide, sizeIn(600), "it stays small");
    }
}
