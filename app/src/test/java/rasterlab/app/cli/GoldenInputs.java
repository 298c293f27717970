package rasterlab.app.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The inputs whose answers are held to what was published. */
final class GoldenInputs {
    private GoldenInputs() {}

    static List<String> of(String topic) throws IOException {
        try (InputStream in = GoldenInputs.class.getResourceAsStream("../golden/inputs.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> line.startsWith(topic + " "))
                    .map(line -> line.substring(topic.length() + 1))
                    .toList();
        }
    }
}
