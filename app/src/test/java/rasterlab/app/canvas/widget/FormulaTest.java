package rasterlab.app.canvas.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.widget.Formula.FormulaWords;
import rasterlab.app.canvas.widget.Formula.Matrix;

class FormulaTest {
    @Test
    void assistiveTechnologyReadsRowByRow() {
        var matrix = new Matrix(List.of(List.of("1", "2"), List.of("3", "4")));
        assertEquals("M = [1 2; 3 4]", Formula.of(new FormulaWords("M ="), matrix).plainText());
        assertEquals("[0,5 1]", Matrix.row(Stream.of("0,5", "1")).plainText());
    }

    @Test
    void raggedMatrixIsRefused() {
        assertThrows(
                IllegalArgumentException.class,
                () -> new Matrix(List.of(List.of("1", "2"), List.of("3"))));
        assertThrows(IllegalArgumentException.class, () -> new Matrix(List.of()));
    }

    @Test
    void headsStandForEachColumn() {
        var headed = new Formula.Matrix(List.of("a", "b"), List.of(List.of("1", "2")));
        assertEquals("a b: [1 2]", headed.plainText());
        assertThrows(
                IllegalArgumentException.class,
                () -> new Formula.Matrix(List.of("a"), List.of(List.of("1", "2"))));
    }
}
