package rasterlab.app.cli.study;

import java.util.LinkedHashMap;
import java.util.Map;
import rasterlab.app.cli.run.TopicRunner;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/**
 * Describes the JSON of a topic in one language; names of fields and values are the same in each.
 * English is taken where a form has no words.
 */
record FormWords(Language language) {

    String reads(TopicRunner<?> run) {
        return texts(run.format().topic()).textOr("reads", run.format().reads());
    }

    String answers(TopicRunner<?> run) {
        return texts(run.format().topic()).textOr("answers", run.format().answers());
    }

    /** The topic's vocabulary: what each name means. */
    Map<String, String> vocabulary(Topic<?, ?, ?> topic) {
        var words = new LinkedHashMap<String, String>(topic.vocabulary());
        Texts texts = texts(topic);
        words.replaceAll((word, english) -> texts.textOr("word." + word, english));
        if (topic.name().equals("matrix") && language != Language.ENGLISH)
            for (NamedMatrix matrix : NamedMatrices.all())
                words.put(matrix.usage(), matrixText(matrix));
        return words;
    }

    private String matrixText(NamedMatrix matrix) {
        String meaning =
                Texts.ofTopic("matrix", language)
                        .textOr("matrix." + matrix.name(), matrix.meaning());
        String inverse = Complaints.translated(language, matrix.inverse().text());
        return Texts.of("cli", "report", language).text("meaning.matrix", meaning, inverse);
    }

    private Texts texts(Topic<?, ?, ?> topic) {
        return Texts.ofTopic(topic.name(), language);
    }
}
