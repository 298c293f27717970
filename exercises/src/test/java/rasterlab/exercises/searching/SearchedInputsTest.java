package rasterlab.exercises.searching;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.searching.TreeParts.TreePlace;

class SearchedInputsTest {
    private static <C, I, O> List<JsonNode> ofStudy(Topic<C, I, O> topic) {
        Method<C> any = topic.methods().get(0);
        return new SearchedInputs<>(topic, any.name(), any.implementation()).ofStudy();
    }

    @ParameterizedTest(name = "{0}: corners of what was cut off stay, or keep all from being cut")
    @CsvSource({"visible-faces, 20", "vertex-normals, 3"})
    void largeInputsOfTheStudyAreCutToWhatTheirFirstItemsNeed(String topic, int least) {
        List<JsonNode> trees = ofStudy(Topics.named(topic));
        assertTrue(trees.size() >= least, "only " + trees.size());
        for (JsonNode tree : trees)
            assertTrue(new TreeParts(tree).leaves().size() <= 400, tree::toString);
    }

    @Test
    @DisplayName("no input has squares that all overflow, or all vanish")
    void inputsAreScaledToWhereSquaresOverflowOrVanish() throws Exception {
        String points = "{\"points\":[[1,2],[3,4],[5,6],[7,8],[9,8],[7,6]]}";
        JsonNode tree = new ObjectMapper().readTree(points);
        var mutation = new TreeMutation(new Random(7));
        var seen = new boolean[2];
        for (int i = 0; i < 2000; i++) {
            List<TreePlace> numbers = new TreeParts(mutation.changed(tree)).numbers();
            if (numbers.size() != 12) continue;
            seen[0] |= numbers.stream().allMatch(n -> Double.isInfinite(square(n)));
            seen[1] |=
                    numbers.stream().allMatch(n -> square(n) == 0 && n.value().doubleValue() != 0);
        }
        assertEquals(List.of(true, true), List.of(seen[0], seen[1]));
    }

    private static double square(TreePlace number) {
        double value = number.value().doubleValue();
        return value * value;
    }
}
