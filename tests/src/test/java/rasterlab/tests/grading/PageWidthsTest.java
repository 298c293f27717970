package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Pages with wide tables are no wider than the window: the tables are scrolled in their own box.
 */
@Tag("slow")
class PageWidthsTest {
    private static final List<String> PAGES =
            List.of(
                    "/instructor/audit",
                    "/instructor/exercises/line-bresenham/similarity",
                    "/instructor/staff",
                    "/instructor/workers");

    @TempDir private Path folder;
    @TempDir private Path profile;

    @Test
    @DisplayName("a table makes the whole page wider than the window")
    void pagesFitTheWindow() throws Exception {
        try (var server = ServerProcess.start(folder.resolve("course"));
                var browser = Browser.open(profile, "en")) {
            fill(GraderClient.of(server.address(), server.token()));
            browser.driver().get(server.address().toString());
            browser.fill("token", server.token());
            browser.element("form[action='/sign-in'] button").click();
            browser.element("form[action='/sign-out']");
            List<String> wider = new ArrayList<>();
            for (int width : List.of(390, 600, 800, 1280)) {
                measure(browser, width);
                for (String page : PAGES) {
                    browser.driver().get(server.address().resolve(page).toString());
                    browser.element("table.stacked tbody tr");
                    browser.screenshot("width-" + width + page.replace('/', '-'));
                    var scrolled =
                            (Number)
                                    browser.driver()
                                            .executeScript(
                                                    "return document.documentElement.scrollWidth");
                    if (scrolled.intValue() > width)
                        wider.add(page + " at " + width + ": " + scrolled);
                }
            }
            assertEquals(List.of(), wider);
        }
    }

    /** Makes programs that are alike, and changes to tell of. */
    private static void fill(GraderClient instructor) throws Exception {
        String name = "Introduction to Computer Graphics and Visualization";
        var course = instructor.post("/courses", "{\"name\":\"" + name + "\"}");
        String code = course.path("code").asText();
        for (String student :
                List.of("Ada King, Countess of Lovelace", "Emmy Noether of Erlangen")) {
            String joining = "{\"course\":\"" + code + "\",\"name\":\"" + student + "\"}";
            var each = instructor.as(instructor.post("/join", joining).path("token").asText());
            each.result(each.submit("line-bresenham", Solutions.source(Solutions.RIGHT)));
        }
        String exam =
                "{\"name\":\"Midterm\",\"exercises\":[\"line-bresenham\"],\"minutes\":60,\"grace\":0,"
                        + "\"opens\":\"2026-01-01T00:00\",\"closes\":\"2098-01-01T00:00\"}";
        instructor.post("/courses/" + course.path("course").asText() + "/exams", exam);
    }

    private static void measure(Browser browser, int width) {
        browser.driver()
                .executeCdpCommand(
                        "Emulation.setDeviceMetricsOverride",
                        Map.of(
                                "width",
                                width,
                                "height",
                                1000,
                                "deviceScaleFactor",
                                1,
                                "mobile",
                                false));
    }
}
