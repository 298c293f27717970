package rasterlab.app.cli.study;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Texts;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.HazardTrial.VerdictCell;

/** The method × hazard table as text. */
final class HazardText {
    private HazardText() {}

    static void print(HazardMatrix matrix, PrintStream out, Texts texts) {
        List<String> heads = new ArrayList<>(List.of(matrix.topic()));
        heads.addAll(matrix.methods());
        var table = new TextTable(heads);
        var words = new StudyWords(texts.language());
        for (String hazard : matrix.hazards()) {
            List<String> row = new ArrayList<>(List.of(hazard));
            for (String method : matrix.methods())
                row.add(marked(matrix.cell(hazard, method), words));
            table.add(row);
        }
        table.lines().forEach(out::println);
        matrix.cells().stream()
                .filter(cell -> !cell.asRecorded())
                .map(cell -> difference(cell, texts))
                .forEach(out::println);
    }

    /** The verdict, with "!" where it is not the recorded one. */
    private static String marked(VerdictCell cell, StudyWords words) {
        return words.verdict(cell.verdict().kind()) + (cell.asRecorded() ? "" : " !");
    }

    private static String difference(VerdictCell cell, Texts texts) {
        String detail = cell.verdict().detail();
        var words = new StudyWords(texts.language());
        String differs =
                texts.text(
                        "differs",
                        cell.method(),
                        cell.hazard(),
                        words.verdict(cell.verdict().kind()),
                        words.verdict(cell.recorded()));
        return differs
                + (detail.isEmpty()
                        ? ""
                        : "; " + VerdictDetail.saidToTypist(texts.language(), detail));
    }
}
