package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.catalogue.Catalogue;

@Tag("slow")
class SpeedMemoryTest {
    @Test
    @DisplayName("a judge remembers by itself what others should remember for it")
    void theJudgeAsksTheMemoryThatItIsGiven() throws Exception {
        Exercise exercise = Catalogue.builtIn().named("line-bresenham");
        List<String> asked = new ArrayList<>();
        SpeedMemory memory =
                new SpeedMemory() {
                    @Override
                    public OptionalInt band(String key) {
                        asked.add(key);
                        return OptionalInt.empty();
                    }

                    @Override
                    public void keep(String key, int band) {
                        assertEquals(asked, List.of(key));
                    }
                };
        try (Judge judge = Judge.start(JudgeSettings.once(), memory)) {
            judge.grade(exercise, Sources.RIGHT, CaseSelection.open(), one -> {});
        }
        assertEquals(List.of(SpeedMemory.key(exercise, Sources.RIGHT)), asked);
    }
}
