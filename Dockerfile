# For those without Debian: docker build -t javino . && docker run --init -it javino
# Not run by Docker yet; `sudo .ci/debian Dockerfile` runs its steps on a new Debian.
FROM debian:trixie
ENV LANG=C.UTF-8
COPY . /javino
WORKDIR /javino
RUN ./setup.sh
RUN gradle --console plain install
CMD gradle --console plain highway
