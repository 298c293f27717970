package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonStreamContext;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;

/** A number of a JSON text that no double holds, such as 1e309, as it stands there. */
final class EndlessNumber {
    private EndlessNumber() {}

    /**
     * @param json which was read before
     * @param path of the number, such as {@code $.camera.rho}
     */
    static String at(String path, String json) {
        try (JsonParser parser = JsonText.parserWithEndlessNumbers(json)) {
            while (parser.nextToken() != null)
                if (isEndless(parser) && path.equals(path(parser.getParsingContext())))
                    return parser.getText();
        } catch (IOException e) {
            throw new AssertionError("a text that was read is no JSON", e);
        }
        throw new AssertionError("there is no endless number at " + path);
    }

    private static boolean isEndless(JsonParser parser) throws IOException {
        return parser.currentToken() == JsonToken.VALUE_NUMBER_FLOAT
                && !Double.isFinite(parser.getDoubleValue());
    }

    private static String path(JsonStreamContext context) {
        if (context.inRoot()) return "$";
        String outer = path(context.getParent());
        return context.inArray()
                ? outer + "[" + context.getCurrentIndex() + "]"
                : outer + "." + context.getCurrentName();
    }
}
