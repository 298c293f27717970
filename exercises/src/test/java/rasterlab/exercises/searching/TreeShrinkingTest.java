package rasterlab.exercises.searching;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;

class TreeShrinkingTest {
    @Test
    void itemsThatDoNotMatterGoAndNumbersBecomeTheSmallestThatFail() throws Exception {
        assertEquals(
                "{\"points\":[[5,0]]}",
                shrunk(
                        "{\"points\":[[1.5,2],[37.25,-1e300],[3,4]],\"more\":true}",
                        tree -> any(tree, x -> x >= 5)));
    }

    @Test
    void equalNumbersShrinkTogether() throws Exception {
        assertEquals(
                "{\"points\":[[5,5]]}",
                shrunk(
                        "{\"points\":[[37.25,37.25]]}",
                        tree -> {
                            JsonNode point = tree.path("points").path(0);
                            double x = point.path(0).doubleValue();
                            return x >= 5 && x == point.path(1).doubleValue();
                        }));
    }

    private static boolean any(JsonNode tree, Predicate<Double> large) {
        for (JsonNode point : tree.path("points"))
            if (large.test(point.path(0).doubleValue()) && point.size() == 2) return true;
        return false;
    }

    private static String shrunk(String json, Predicate<JsonNode> fails)
            throws JsonProcessingException {
        JsonNode tree = new ObjectMapper().readTree(json);
        return new TreeShrinking(fails, simpler -> {}, () -> false).shrunk(tree).toString();
    }
}
