package rasterlab.exercises.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.json.SentencesFile;

/** Holds every sentence about a place of a scene file to what people have read so far. */
class PlaceSentencesTest {
    private static final List<String> VALUES =
            List.of(
                    "null",
                    "true",
                    "7",
                    "7.0",
                    "1e2",
                    "1E400",
                    "-Infinity",
                    "NaN",
                    "0.1e-3",
                    "-3000000000",
                    "\"\"",
                    "\" \"",
                    "\"two\"",
                    "[]",
                    "[1]",
                    "[1, 2]",
                    "[1, \"2\"]",
                    "[1, 2.5]",
                    "[1, NaN]",
                    "[{}]",
                    "{}",
                    "{\"z\": 1}",
                    "{\"z\": [1, {\"y\": 1e999}]}",
                    "\"" + "x".repeat(80) + "\"");

    private static final Map<String, Function<SceneJsonPlace, Object>> READERS = readers();

    private static Map<String, Function<SceneJsonPlace, Object>> readers() {
        var readers = new TreeMap<String, Function<SceneJsonPlace, Object>>();
        readers.put("flag", SceneJsonPlace::flag);
        readers.put("integer", place -> place.integer(0, 9));
        readers.put("json", SceneJsonPlace::json);
        readers.put("made", place -> place.made(PlaceSentencesTest::refuse));
        readers.put("members", place -> place.members().size());
        readers.put("name or object", place -> place.nameOrObject().has("z"));
        readers.put("number", place -> place.number(-2, 50));
        readers.put("numbers", place -> Arrays.toString(place.numbers(2, 0, 2)));
        readers.put("object", place -> place.object("a", "b").has("a"));
        readers.put("object of any", place -> place.object().has("a"));
        readers.put("one", place -> place.integer(1, 1));
        readers.put("optional", place -> place.optional("z").map(SceneJsonPlace::text));
        readers.put("text", SceneJsonPlace::text);
        return readers;
    }

    private static Object refuse(SceneJsonPlace place) {
        if (place.isText()) throw new IllegalArgumentException("texts are refused");
        return place.at("z").flag();
    }

    @Test
    void areSaidAsBefore() {
        List<String> said = SentencesFile.ofField(READERS, VALUES, PlaceSentencesTest::sentence);
        for (String whole : List.of("", "{", "{} 7", "{\"f\": 1, \"f\": 2}", "[1"))
            said.add("whole " + whole + ": " + sentence(place -> "read", whole));
        assertEquals(SentencesFile.read("places.txt", said), said);
    }

    private static String sentence(Function<SceneJsonPlace, Object> reader, String json) {
        try {
            return "" + reader.apply(SceneJsonPlace.root(json).at("f"));
        } catch (IllegalArgumentException e) {
            return e.getMessage();
        }
    }
}
