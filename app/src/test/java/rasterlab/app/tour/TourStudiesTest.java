package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.Study;
import rasterlab.engine.transform.matrix.MatrixTopic;

class TourStudiesTest {
    @Test
    @DisplayName("a topic is measured again when it is asked for again")
    void topicIsMeasuredOnce() {
        var studies = new TourStudies();
        Study first = studies.of(new MatrixTopic());
        assertEquals("matrix", first.topic());
        assertSame(first, studies.of(new MatrixTopic()));
    }
}
