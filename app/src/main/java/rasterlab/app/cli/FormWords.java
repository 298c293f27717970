package rasterlab.app.cli;

import java.util.LinkedHashMap;
import java.util.Map;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.cli.run.TopicRunner;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/**
 * What the JSON of a topic looks like, in one language; names of fields and values are the same in
 * each. English is taken where a form has no words.
 *
 * @param texts what stands for the English of the forms
 */
record FormWords(Texts texts, Texts report) {
    FormWords(Language language) {
        this(Texts.of("cli", "topic", language), Texts.of("cli", "report", language));
    }

    String reads(TopicRunner<?> run) {
        return texts.textOr(run.format().topic().name() + ".reads", run.format().reads());
    }

    String answers(TopicRunner<?> run) {
        return texts.textOr(run.format().topic().name() + ".answers", run.format().answers());
    }

    /** The topic's vocabulary: what each name means. */
    Map<String, String> vocabulary(Topic<?, ?, ?> topic) {
        var words = new LinkedHashMap<String, String>(topic.vocabulary());
        words.replaceAll((word, english) -> texts.textOr(topic.name() + ".word." + word, english));
        if (topic.name().equals("matrix") && texts.language() != Language.ENGLISH)
            for (NamedMatrix matrix : NamedMatrices.all()) words.put(matrix.usage(), said(matrix));
        return words;
    }

    private String said(NamedMatrix matrix) {
        String meaning =
                TopicTexts.of(LabRooms.card("matrix"), texts.language())
                        .texts()
                        .textOr("matrix." + matrix.name(), matrix.meaning());
        String inverse = Complaints.said(texts.language(), matrix.inverse().text());
        return report.text("meaning.matrix", meaning, inverse);
    }
}
