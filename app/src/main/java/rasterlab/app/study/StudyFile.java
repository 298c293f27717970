package rasterlab.app.study;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.study.front.StudyPlot;
import rasterlab.engine.study.Study;

/** The forms in which a study is written, chosen by the file's extension. */
public enum StudyFile {
    SVG {
        @Override
        byte[] content(Study study, StudyPlot plot, StudyCost cost, Language language) {
            return plot.of(cost.of(study), cost.words(language), ChartLook.PAPER)
                    .svg(ChartLook.PAPER);
        }
    },
    PNG {
        @Override
        byte[] content(Study study, StudyPlot plot, StudyCost cost, Language language) {
            return PngFile.bytes(
                    plot.of(cost.of(study), cost.words(language), ChartLook.PAPER)
                            .image(ChartLook.PAPER));
        }
    },
    CSV {
        @Override
        byte[] content(Study study, StudyPlot plot, StudyCost cost, Language language) {
            return StudyCsv.of(study).getBytes(StandardCharsets.UTF_8);
        }
    },
    JSON {
        @Override
        byte[] content(Study study, StudyPlot plot, StudyCost cost, Language language) {
            return StudyJson.of(study);
        }
    };

    /**
     * @param plot which chart
     * @param cost of a chart
     * @param language of a chart; numbers have none
     */
    abstract byte[] content(Study study, StudyPlot plot, StudyCost cost, Language language);

    /**
     * The form that the file's extension names, in capitals or not.
     *
     * @throws Complaint listing the extensions, if there is no such form
     */
    public static StudyFile named(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return Arrays.stream(values())
                .filter(form -> name.endsWith(form.extension()))
                .findFirst()
                .orElseThrow(
                        () ->
                                Complaint.badInput(
                                        file
                                                + ": unknown extension; allowed are "
                                                + String.join(", ", extensions())));
    }

    static List<String> extensions() {
        return Arrays.stream(values()).map(StudyFile::extension).toList();
    }

    private String extension() {
        return "." + name().toLowerCase(Locale.ROOT);
    }

    /**
     * Writes the study, whole or not at all.
     *
     * @param language of a chart
     * @throws Complaint if the extension is unknown or the file cannot be written
     */
    public static void write(Study study, Path file, Language language) {
        write(study, StudyPlot.FRONT, StudyCost.TIME, file, language);
    }

    /**
     * Writes the study, whole or not at all.
     *
     * @param plot which chart
     * @param cost of a chart
     * @param language of a chart
     * @throws Complaint if the extension is unknown or the file cannot be written
     */
    public static void write(
            Study study, StudyPlot plot, StudyCost cost, Path file, Language language) {
        WholeFile.write(file, named(file).content(study, plot, cost, language));
    }
}
