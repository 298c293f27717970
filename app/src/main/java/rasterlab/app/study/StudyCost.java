package rasterlab.app.study;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.app.language.Language;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/** The quantity that a study's chart has as its cost. */
public enum StudyCost {
    /** Nanoseconds per item. */
    TIME {
        @Override
        public boolean isPossible(Topic<?, ?, ?> topic) {
            return true;
        }

        @Override
        public Study of(Study study) {
            return study;
        }

        @Override
        public StudyWords words(Language language) {
            return new StudyWords(language);
        }
    },
    /** Operations, counted and so free of noise. */
    OPERATIONS {
        @Override
        public boolean isPossible(Topic<?, ?, ?> topic) {
            return CountedStudy.isPossible(topic);
        }

        @Override
        public Study of(Study study) {
            return CountedStudy.of(study);
        }

        @Override
        public StudyWords words(Language language) {
            return StudyWords.ofCounts(language);
        }
    },
    /** Parts that an answer is made of: the least of them that is enough is the best. */
    PARTS {
        @Override
        public boolean isPossible(Topic<?, ?, ?> topic) {
            return topic.parts().isPresent();
        }

        @Override
        public Study of(Study study) {
            return CountedStudy.ofParts(study);
        }

        @Override
        public StudyWords words(Language language) {
            return StudyWords.ofParts(language);
        }
    };

    /** Whether a study of that topic can have such costs. */
    public abstract boolean isPossible(Topic<?, ?, ?> topic);

    /** The study with such costs in place of times. */
    public abstract Study of(Study study);

    /** The words of a chart with such costs. */
    public abstract StudyWords words(Language language);

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static List<String> codes() {
        return Arrays.stream(values()).map(StudyCost::code).toList();
    }
}
