package rasterlab.app.canvas.method;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Verdict;

/**
 * A remark beside a hazard that a tab cannot show as it is, or that a method fails on.
 *
 * @param verdict on the method, for the hazard's own numbers
 * @param differences in what the picture is other
 */
public record HazardNote(
        String hazard, String method, Verdict verdict, List<ShownDifference> differences) {
    public HazardNote {
        differences = List.copyOf(differences);
    }

    public String in(Language language) {
        Texts texts = Texts.of("canvas", language);
        String said =
                texts.text(
                        "note",
                        hazard,
                        OwnWords.called(method, language),
                        Texts.of("study", language).text("verdict." + verdict.kind().code()));
        String detail = verdict.detail();
        boolean failed = verdict.kind() != Verdict.Kind.EXACT;
        if (failed && !detail.isEmpty())
            said += " (" + VerdictDetail.translated(language, detail) + ")";
        return Stream.concat(Stream.of(said), differences.stream().map(each -> each.in(texts)))
                .collect(Collectors.joining(". ", "", "."));
    }
}
