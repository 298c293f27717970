package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

class ModeRowsTest {
    @Test
    void rowIsMadeWhenItIsFirstSeenAndSeenAlone() {
        var made = new ArrayList<String>();
        var rows =
                new ModeRows<String>(
                        mode -> {
                            made.add(mode);
                            return new JLabel(mode);
                        });
        for (String mode : List.of("circle", "pen", "circle")) {
            rows.show(mode);
            assertEquals(
                    List.of(mode),
                    Stream.of(rows.getComponents())
                            .filter(Component::isVisible)
                            .map(row -> ((JLabel) row).getText())
                            .toList());
        }
        assertEquals(List.of("circle", "pen"), made);
    }
}
