package rasterlab.app.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.method.TopicColors;

class MethodLookTest {
    @Test
    @DisplayName("two lines without marks have the same dashes")
    void linesWithoutMarksAreToldByTheirDashes() {
        MethodLook look = MethodLook.of(List.of("one"), new TopicColors(Map.of())).get("one");
        Set<String> dashes = new HashSet<>();
        for (int number = 0; number < 4; number++)
            dashes.add(Arrays.toString(look.unmarked(number).stroke().getDashArray()));
        assertEquals(4, dashes.size(), dashes.toString());
    }
}
