package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;

/**
 * Makes trees of JSON texts that people write or send: files of exercises, scenes and settings,
 * answers handed in, bodies of requests. No field comes twice, and nothing follows the value.
 *
 * <p>The input of a topic, which may be long, is read without a tree: by {@link StrictJson#read}.
 */
public final class JsonText {
    private static final JsonMapper STRICT =
            JsonMapper.builder()
                    .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                    .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                    .build();

    private static final JsonMapper WITH_ENDLESS_NUMBERS =
            STRICT.rebuild().enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();

    private static final JsonMapper WITH_ALL_DIGITS =
            STRICT.rebuild().enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS).build();

    private JsonText() {}

    /** The tree of a text; missing where the text is empty. */
    public static JsonNode tree(String json) throws NotJson {
        return tree(STRICT, json);
    }

    /** Reads JSON with all digits of each number, so that it can be written as it was. */
    public static JsonNode treeWithAllDigits(String json) throws NotJson {
        return tree(WITH_ALL_DIGITS, json);
    }

    /** Reads JSON with NaN and infinite numbers, so that they can be refused with their place. */
    public static JsonNode treeWithEndlessNumbers(String json) throws NotJson {
        return tree(WITH_ENDLESS_NUMBERS, json);
    }

    private static JsonNode tree(JsonMapper mapper, String json) throws NotJson {
        try {
            return mapper.readTree(json);
        } catch (JsonProcessingException e) {
            throw new NotJson(e);
        }
    }

    /** Reads the same text as {@link #treeWithEndlessNumbers}, token by token. */
    static JsonParser parserWithEndlessNumbers(String json) throws IOException {
        return WITH_ENDLESS_NUMBERS.createParser(json);
    }
}
