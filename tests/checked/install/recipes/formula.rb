#!/usr/bin/env ruby
# SPDX-License-Identifier: GPL-3.0-or-later
# formula.rb FORMULA ARCHIVE WORK: what Homebrew does with a formula, of what that of oplus uses: installs from the
# archive of the sources into WORK/prefix, and runs its test.
require "digest"
require "fileutils"
require "pathname"

FORMULA, ARCHIVE, WORK = ARGV.map { |argument| Pathname.new(argument).expand_path }

class Formula
  class << self
    attr_reader :fields, :dependencies, :tests

    def inherited(formula)
      super
      formula.instance_variable_set(:@fields, {})
      formula.instance_variable_set(:@dependencies, [])
    end

    %i[desc homepage url sha256 license].each { |field| define_method(field) { |value| @fields[field] = value } }

    def depends_on(dependency)
      @dependencies << dependency
    end

    def test(&block)
      @tests = block
    end
  end

  def prefix = WORK/"prefix"
  def include = prefix/"include"
  def lib = prefix/"lib"
  def testpath = WORK/"test"

  def std_cmake_args
    ["-DCMAKE_INSTALL_PREFIX=#{prefix}", "-DCMAKE_INSTALL_LIBDIR=lib", "-DCMAKE_BUILD_TYPE=Release"]
  end

  def system(*command)
    Kernel.system(*command.map(&:to_s), out: (WORK/"log").to_s) || abort("failed: #{command.join(" ")}")
  end
end
ENV.define_singleton_method(:cxx) { ENV.fetch("CXX", "c++") }

load FORMULA
fields = Oplus.fields
archive_name = ARCHIVE.basename.to_s
abort "fields: #{fields.keys}" unless fields.keys == %i[desc homepage url sha256 license]
abort "desc is too long, or ends with a stop" if fields[:desc].length > 80 || fields[:desc].end_with?(".")
abort "not the archive's address: #{fields[:url]}" unless fields[:url].match?(%r{\Ahttps://.*/#{archive_name}\z})
abort "the formula is of another archive" unless Digest::SHA256.file(ARCHIVE).hexdigest == fields[:sha256]
built_with = Oplus.dependencies.grep(Hash).map { |dependency| dependency.keys.first }
abort "not in order: #{built_with}" unless built_with == built_with.sort

sources = WORK/"src"
FileUtils.mkdir_p([sources, WORK/"test"])
Kernel.system("tar", "-x", "-f", ARCHIVE.to_s, "-C", sources.to_s, "--strip-components=1") || abort("not an archive")
formula = Oplus.new
Dir.chdir(sources) { formula.install }
Dir.chdir(formula.testpath) { formula.instance_eval(&Oplus.tests) }
