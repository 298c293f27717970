package rasterlab.app.signmap;

import java.util.List;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;
import rasterlab.engine.signmap.SignMap;
import rasterlab.engine.signmap.SignSubject;
import rasterlab.engine.study.Topic;

/** The sentences below sign maps: what is wrong in each, and all numbers that it is made of. */
record SignWords(Texts texts) {
    /** Shares below this one would be written as 0.0 %. */
    private static final double LEAST_SHARE = 0.0005;

    SignWords(Language language) {
        this(Texts.of("signmap", language));
    }

    /** How many answers are wrong, and their share. */
    String share(SignMap map) {
        int wrong = map.extra() + map.missing();
        boolean least = wrong > 0 && map.share() < LEAST_SHARE;
        return texts.text(least ? "share.least" : "share", map.share(), wrong);
    }

    /** The input of each map's first point, a line for all that have the same. */
    List<String> inputs(List<SignMap> maps) {
        return maps.stream().map(this::input).distinct().toList();
    }

    private String input(SignMap map) {
        SignSubject subject = SignSubject.find(map.subject(), SignMaps.subjects());
        String input =
                subject.others()
                        .map(others -> texts.text("point", map.x(0), map.y(0)) + ", " + others)
                        .orElseGet(() -> input(Topics.named(map.subject()), map));
        return texts.text("input." + map.spacing().code(), map.subject(), input);
    }

    private static <I, O> String input(Topic<?, I, O> topic, SignMap map) {
        PointQuestion<I, O> question = topic.question().orElseThrow();
        Spacing spacing = map.spacing();
        return CommandInput.of(topic.format(), question.input(spacing, map.x(0), map.y(0)));
    }
}
