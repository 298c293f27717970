package rasterlab.app.cli.exercise;

import java.util.List;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Texts;
import rasterlab.exercises.proving.Kill;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.proving.RightMethod;
import rasterlab.exercises.proving.SourcePoints;
import rasterlab.exercises.score.Phrase;

/** A proof as text for a terminal. */
final class ProofText {
    private static final String NONE = "–";

    private final Proof proof;
    private final Console console;
    private final Texts texts;

    private ProofText(Proof proof, Console console) {
        this.proof = proof;
        this.console = console;
        this.texts = console.language().texts();
    }

    static void print(Proof proof, Console console) {
        new ProofText(proof, console).print();
    }

    /** Prints who was rejected in each of several, and how many are proved. */
    static void printSummary(List<Proof> proofs, Console console) {
        Texts texts = console.language().texts();
        var table =
                new TextTable(
                        texts.text("exercise"),
                        texts.text("proof.mistakes"),
                        texts.text("proof.rejected"),
                        texts.text("proof.told"),
                        texts.text("proof.faults"));
        for (Proof one : proofs) table.add(summary(one));
        table.lines().forEach(console.out()::println);
        console.out().println();
        long proved = proofs.stream().filter(one -> one.faults().isEmpty()).count();
        console.out().println(texts.text("proof.summary", proved, proofs.size()));
    }

    private static List<String> summary(Proof proof) {
        List<Kill> asked = proof.kills().stream().filter(Kill::asked).toList();
        return List.of(
                proof.exercise().id(),
                "" + asked.size(),
                "" + asked.stream().filter(Kill::isRejected).count(),
                "" + asked.stream().filter(one -> one.isRejected() && one.isNamed()).count(),
                proof.faults().isEmpty() ? NONE : "" + proof.faults().size());
    }

    private void print() {
        String id = proof.exercise().id();
        console.out().println(id + ", " + proof.exercise().title(console.language().code()));
        console.out().println();
        lines(right());
        lines(kills());
        proof.starter().ifPresent(points -> say("proof.starter", points));
        proof.model().ifPresent(points -> say("proof.model", points));
        for (Phrase fault : proof.faults())
            console.out().println("  ! " + fault.in(console.language().code()));
        String verdict = proof.faults().isEmpty() ? "proof.proved" : "proof.not";
        console.out().println("  " + texts.text(verdict, id));
        console.out().println();
    }

    private void lines(TextTable table) {
        table.lines().forEach(line -> console.out().println("  " + line));
        console.out().println();
    }

    private void say(String key, SourcePoints points) {
        console.out()
                .println(
                        "  "
                                + texts.text(
                                        key,
                                        points.points().accuracy(),
                                        points.points().stability(),
                                        points.timed() ? points.points().speed() : NONE));
    }

    private TextTable right() {
        var table =
                new TextTable(
                        texts.text("proof.right"),
                        texts.text("proof.accuracy"),
                        texts.text("proof.stability"),
                        texts.text("proof.loses"));
        for (RightMethod one : proof.right())
            table.add(
                    List.of(
                            one.promised() ? one.name() : texts.text("proof.may-err", one.name()),
                            "" + one.accuracy(),
                            "" + one.stability(),
                            one.failed().isEmpty() ? NONE : String.join(", ", one.failed())));
        return table;
    }

    private TextTable kills() {
        var table =
                new TextTable(
                        texts.text("proof.mistake"),
                        texts.text("proof.cases"),
                        texts.text("proof.named"),
                        texts.text("proof.properties"),
                        texts.text("proof.first"));
        for (Kill one : proof.kills())
            table.add(
                    List.of(
                            one.mistake(),
                            "" + one.cases().size(),
                            "" + one.naming().size(),
                            "" + one.properties().size(),
                            first(one)));
        return table;
    }

    /** The case that tells it best: one that names it, else one that rejects it. */
    private String first(Kill one) {
        if (!one.asked() && !one.isRejected()) return texts.text("proof.not-asked");
        if (!one.naming().isEmpty()) return one.naming().get(0);
        return one.isRejected() ? one.cases().get(0) : NONE;
    }
}
