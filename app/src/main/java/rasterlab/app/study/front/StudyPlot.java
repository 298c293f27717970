package rasterlab.app.study.front;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.study.chart.StudyChart;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Study;

/** The charts that can be drawn of a study. */
public enum StudyPlot {
    FRONT {
        @Override
        public StudyPicture of(Study study, StudyWords words, ChartLook paper) {
            return new FrontChart(study, words, paper);
        }
    },
    SIZES {
        @Override
        public StudyPicture of(Study study, StudyWords words, ChartLook paper) {
            return (graphics, width, height) -> StudyChart.paint(study, words, paper, graphics);
        }
    },
    COST_GROWTH {
        @Override
        public StudyPicture of(Study study, StudyWords words, ChartLook paper) {
            return new SizesChart(study, SizesChart.Of.COST, words, paper);
        }
    },
    ERROR_GROWTH {
        @Override
        public StudyPicture of(Study study, StudyWords words, ChartLook paper) {
            return new SizesChart(study, SizesChart.Of.ERROR, words, paper);
        }
    },
    ERROR_BY_INPUT {
        @Override
        public StudyPicture of(Study study, StudyWords words, ChartLook paper) {
            return new ErrorByInputChart(study, words, paper);
        }
    };

    /** The chart of that study. */
    public abstract StudyPicture of(Study study, StudyWords words, ChartLook paper);

    /** Lower-case with hyphens, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    public static List<String> codes() {
        return Arrays.stream(values()).map(StudyPlot::code).toList();
    }
}
