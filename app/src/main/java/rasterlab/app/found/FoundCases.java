package rasterlab.app.found;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.app.canvas.lab.HazardCase;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.lab.OwnCase;
import rasterlab.app.canvas.lab.OwnChips;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.scene.MethodCase;

/** The user's finds as chips of the lab that shows their topic. */
public final class FoundCases implements OwnChips.CaseFinder {
    private final FoundHazards kept;
    private final OpenInLab opening;
    private final Texts texts;
    private final Texts verdicts;

    /**
     * @param opening shows their inputs
     */
    public FoundCases(FoundHazards kept, OpenInLab opening, Language language) {
        this.kept = kept;
        this.opening = opening;
        texts = Texts.of("found", language);
        verdicts = Texts.of("study", language);
    }

    /** The finds that the lab can show; none of a topic of which it reads no inputs. */
    @Override
    public List<OwnCase> of(String topic) {
        if (opening.obstacleToInputs(topic).isPresent()) return List.of();
        List<String> methods =
                Topics.named(topic).methods().stream().<String>map(Method::name).toList();
        return kept.of(topic).stream().map(each -> found(each, methods)).toList();
    }

    private OwnCase found(FoundHazards.KeptFind find, List<String> methods) {
        MethodCase scene = find.scene();
        String method = scene.method().orElse("");
        Optional<Verdict.Kind> verdict = scene.found().flatMap(FoundCases::verdict);
        boolean judged = verdict.isPresent() && methods.contains(method);
        String said =
                verdict.map(kind -> texts.text("special", method, word(kind), seed(scene)))
                        .orElseGet(() -> texts.text("special.unjudged", method));
        var hazard =
                new HazardCase(
                        find.name(),
                        texts.text("chip", method),
                        said,
                        judged ? List.of(method) : List.of(),
                        judged ? Map.of(method, verdict.get()) : Map.of(),
                        () -> show(scene, methods.contains(method) ? method : ""));
        return new OwnCase(hazard, texts.text("remove"), () -> kept.remove(find));
    }

    private void show(MethodCase scene, String method) {
        opening.showInput(scene.topic(), scene.input(), method, Optional.empty());
    }

    private String word(Verdict.Kind kind) {
        return verdicts.text("verdict." + kind.code());
    }

    private static int seed(MethodCase scene) {
        return scene.found().map(MethodCase.SearchFinding::seed).orElse(0);
    }

    private static Optional<Verdict.Kind> verdict(MethodCase.SearchFinding found) {
        return Stream.of(Verdict.Kind.values())
                .filter(kind -> kind.code().equals(found.verdict()))
                .findFirst();
    }
}
