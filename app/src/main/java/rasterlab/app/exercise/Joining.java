package rasterlab.app.exercise;

import java.io.IOException;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.ServerRefusal;

/** How somebody comes to an account: by a course's code, or by a token. */
interface Joining {
    /**
     * @throws ServerRefusal if the server does not know the code or the token
     */
    Account with(CourseServer server) throws IOException, InterruptedException;
}
