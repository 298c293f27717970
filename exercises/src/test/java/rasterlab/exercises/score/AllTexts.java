package rasterlab.exercises.score;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Properties;
import rasterlab.engine.Topics;
import rasterlab.exercises.words.TopicWords;

/** All texts of reports in one language, those on topics by the keys that reports have. */
final class AllTexts {
    private static final List<String> OF_TOPICS =
            List.of("mutant.", "slip.", "property.", "place.", "decided.", "rule.", "bound.");

    private AllTexts() {}

    /**
     * @param file beside {@link Message}, {@code messages.properties} or its Russian
     */
    static Properties in(String file) throws IOException {
        Properties all = read(Message.class, file);
        for (String topic : Topics.names())
            read(TopicWords.class, file.replace("messages", topic))
                    .forEach((key, text) -> add(topic, (String) key, text, all));
        return all;
    }

    private static void add(String topic, String key, Object text, Properties all) {
        for (String kind : OF_TOPICS)
            if (key.startsWith(kind))
                all.put(kind + topic + "." + key.substring(kind.length()), text);
    }

    private static Properties read(Class<?> beside, String file) throws IOException {
        var texts = new Properties();
        try (InputStream in = beside.getResourceAsStream(file)) {
            texts.load(new InputStreamReader(in, StandardCharsets.UTF_8));
        }
        return texts;
    }
}
