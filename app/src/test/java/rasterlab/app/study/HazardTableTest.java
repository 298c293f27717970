package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

class HazardTableTest {
    @Test
    @DisplayName("the drawing of the table lacks a method, a hazard or the verdicts")
    void svgHasTheWholeTable() {
        List<Throwable> failures = new ArrayList<>();
        try (var model =
                new StudyLabModel(List.of(new LineTopic()), Runnable::run, failures::add)) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            table.scroll();
            table.refresh();
            String svg = table.svg();
            for (Method<?> method : model.state().topic().methods())
                assertTrue(svg.contains(">" + method.name() + "<"), method.name());
            for (Hazard<?> hazard : model.state().topic().hazards())
                assertTrue(svg.contains(">" + hazard.name() + "<"), hazard.name());
            int methods = model.state().topic().methods().size();
            int hazards = model.state().topic().hazards().size();
            long verdicts = svg.chars().filter(sign -> "✓≈✗–∞†".indexOf(sign) >= 0).count();
            assertEquals(methods * hazards, verdicts);
        }
        assertEquals(List.of(), failures);
    }
}
